//! What assemblies are given.

use super::arguments::Arguments;
use super::resolver::Resolver;
use super::value::Value;
use crate::diagnostics::Place;
use crate::syntax::{Entry, Given, Port, Receiver, Takes, exactly};
use syn::Expr;

impl Resolver<'_> {
    /// Whether parameters are given values of their own dimensions.
    pub(super) fn given_parameters(&mut self) -> bool {
        self.each_given(|resolver, given| {
            if let Receiver::Parameter(parameter) = &given.to {
                resolver.check_parameter(&given.assembly, parameter, &given.value);
            }
        })
    }

    /// Whether ports are given what they take: otherwise the entries of the assembly would say the same again.
    pub(super) fn given_ports(&mut self) -> bool {
        self.each_given(|resolver, given| {
            if let Receiver::Port(port) = &given.to {
                resolver.check_port(&given.assembly, port, &given.value);
            }
        })
    }

    /// Whether there are no errors.
    fn each_given(&mut self, check: impl Fn(&mut Self, &Given)) -> bool {
        let found = self.errors.count();
        for given in &self.declaration.given {
            let before = self.errors.enter(&given.instance);
            check(self, given);
            self.errors.leave(before);
        }
        self.errors.count() == found
    }

    fn check_parameter(&mut self, assembly: &str, parameter: &Entry, value: &Expr) {
        // What is wrong with the default is said where it is declared.
        let default = self.silently(|resolver| Arguments::new(resolver, parameter).number("value"));
        let Some((_, Some(own))) = default else {
            return;
        };
        if let Some(Value::Scalar(_, Some(found))) = self.evaluate(value)
            && found != own
        {
            let name = &parameter.name;
            self.fail::<()>(
                Place::of(value),
                format!("the parameter `{name}` of `{assembly}` is {own}, but this is {found}"),
            );
        }
    }

    fn check_port(&mut self, assembly: &str, port: &Port, value: &Expr) {
        let Some(found) = self.evaluate(exactly(value).unwrap_or(value)) else {
            return;
        };
        let fits = match port.takes {
            Takes::Point => matches!(found, Value::Point(_)),
            Takes::Part => matches!(found, Value::Frame(_)),
            Takes::Frame => matches!(found, Value::Attachment(_)),
            Takes::Number => matches!(found, Value::Scalar(..)),
            Takes::Vector => matches!(found, Value::Vector(..)),
            Takes::Table => matches!(found, Value::Table(..)),
        };
        if !fits {
            let (name, takes, found) = (&port.name, port.takes.describe(), found.describe());
            self.fail::<()>(
                Place::of(value),
                format!("the port `{name}` of `{assembly}` takes {takes}, but this is {found}"),
            );
        }
    }
}
