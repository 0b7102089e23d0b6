#pragma once
// How this room calls Boost.Math: in double precision throughout, because long double differs between machines; values
// outside a function's domain give NaN or infinity instead of exceptions, because callers check their input themselves.

#include <boost/math/policies/policy.hpp>

namespace netpocket {

namespace boost_policies = boost::math::policies;
using BoostPolicy = boost_policies::policy<boost_policies::promote_double<false>, boost_policies::promote_float<false>,
                                           boost_policies::domain_error<boost_policies::ignore_error>,
                                           boost_policies::pole_error<boost_policies::ignore_error>,
                                           boost_policies::overflow_error<boost_policies::ignore_error>,
                                           boost_policies::evaluation_error<boost_policies::ignore_error>>;

}  // namespace netpocket
