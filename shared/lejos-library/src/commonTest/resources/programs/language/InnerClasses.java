import josx.platform.rcx.LCD;

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
        LCD.showNumber(outer.measure()); // shows: 9
        InnerClasses.Inner inner = outer.new Inner();
        LCD.showNumber(inner.sum()); // shows: 7
        Inner.Innermost innermost = inner.new Innermost();
        LCD.showNumber(innermost.all()); // shows: 44
        LCD.showNumber(outer.value); // shows: 4
    }
}
