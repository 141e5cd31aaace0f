public class NestedClasses {
    private int counter = 10;

    class Inner {
        int number = counter++;

        class Deeper {
            int sum() {
                return number + counter;
            }
        }
    }

    static class Base {
        protected String name = "base";

        Base() {
            describe();
        }

        void describe() {
            System.out.println("base");
        }
    }

    static class Derived extends Base {
        private String own = "own";

        @Override
        void describe() {
            System.out.println("derived " + own + " " + name);
        }
    }

    interface Action {
        int run(int value);
    }

    static Action adding(final int amount) {
        class Adder implements Action {
            public int run(int value) {
                return value + amount;
            }
        }
        return new Adder();
    }

    static Action chained(final Action first, final Action second) {
        return new Action() {
            public int run(int value) {
                return second.run(first.run(value));
            }
        };
    }

    public static void main(String[] arguments) {
        NestedClasses outer = new NestedClasses();
        Inner inner = outer.new Inner();
        Inner.Deeper deeper = inner.new Deeper();
        System.out.println(inner.number + " " + outer.counter + " " + deeper.sum());
        new Derived().describe();
        System.out.println(chained(adding(3), adding(4)).run(5));
        System.out.println(new Object() {
            int hidden = 7;

            @Override
            public String toString() {
                return "anonymous " + hidden;
            }
        });
    }
}

// It prints:
// expect 10 11 21
// expect derived null base
// expect derived own base
// expect 12
// expect anonymous 7
