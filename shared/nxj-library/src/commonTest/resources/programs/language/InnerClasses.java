public class InnerClasses {
    private int value = 3;

    class Inner {
        private int own = 4;

        int sum() {
            return value + own;
        }

        class Innermost {
            int all() {
                value++;
                return value * 10 + own;
            }
        }
    }

    int measure() {
        Inner inner = new Inner();
        inner.own = 6;
        return inner.sum();
    }

    public static void main(String[] arguments) {
        InnerClasses outer = new InnerClasses();
        System.out.println(outer.measure()); // expect 9
        InnerClasses.Inner inner = outer.new Inner();
        System.out.println(inner.sum()); // expect 7
        Inner.Innermost innermost = inner.new Innermost();
        System.out.println(innermost.all()); // expect 44
        System.out.println(outer.value); // expect 4
    }
}
