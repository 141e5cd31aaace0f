import java.util.ArrayList;
import java.util.List;

public class InterfacesAtWork {
    interface Visitor<R> {
        R number(int value);

        R sum(Expression left, Expression right);

        R product(Expression left, Expression right);
    }

    interface Expression {
        <R> R accept(Visitor<R> visitor);
    }

    static Expression number(final int value) {
        return new Expression() {
            public <R> R accept(Visitor<R> visitor) {
                return visitor.number(value);
            }
        };
    }

    static Expression sum(final Expression left, final Expression right) {
        return new Expression() {
            public <R> R accept(Visitor<R> visitor) {
                return visitor.sum(left, right);
            }
        };
    }

    static Expression product(final Expression left, final Expression right) {
        return new Expression() {
            public <R> R accept(Visitor<R> visitor) {
                return visitor.product(left, right);
            }
        };
    }

    static class Value implements Visitor<Integer> {
        public Integer number(int value) {
            return value;
        }

        public Integer sum(Expression left, Expression right) {
            return left.accept(this) + right.accept(this);
        }

        public Integer product(Expression left, Expression right) {
            return left.accept(this) * right.accept(this);
        }
    }

    static class Shown implements Visitor<String> {
        public String number(int value) {
            return "" + value;
        }

        public String sum(Expression left, Expression right) {
            return "(" + left.accept(this) + "+" + right.accept(this) + ")";
        }

        public String product(Expression left, Expression right) {
            return left.accept(this) + "*" + right.accept(this);
        }
    }

    interface Listener {
        void changed(String what);
    }

    static class Model {
        private final List<Listener> listeners = new ArrayList<Listener>();

        void add(Listener listener) {
            listeners.add(listener);
        }

        void change(String what) {
            for (Listener listener : listeners) listener.changed(what);
        }
    }

    public static void main(String[] arguments) {
        Expression expression = sum(number(2), product(number(3), sum(number(4), number(5))));
        System.out.println(expression.accept(new Value()) + " " + expression.accept(new Shown())); // expect 29 (2+3*(4+5))
        Model model = new Model();
        final StringBuilder log = new StringBuilder();
        for (int i = 0; i < 3; i++) {
            final int number = i;
            model.add(new Listener() {
                public void changed(String what) {
                    log.append(what).append(number).append(' ');
                }
            });
        }
        model.change("a");
        model.change("b");
        System.out.println(log.toString().trim()); // expect a0 a1 a2 b0 b1 b2
    }
}
