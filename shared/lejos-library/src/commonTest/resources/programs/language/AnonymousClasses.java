import josx.platform.rcx.LCD;

public class AnonymousClasses {
    interface Rule {
        int apply(int number);
    }

    static int apply(Rule rule, int number) {
        return rule.apply(number);
    }

    public static void main(String[] arguments) {
        final int factor = arguments == null ? 3 : 4;
        Rule triple = new Rule() {
            private int calls = 0;

            public int apply(int number) {
                calls++;
                return number * factor + calls;
            }
        };
        LCD.showNumber(apply(triple, 10)); // shows: 31
        LCD.showNumber(apply(triple, 10)); // shows: 32
        class Local implements Rule {
            public int apply(int number) {
                return number - factor;
            }
        }
        LCD.showNumber(apply(new Local(), 10)); // shows: 7
    }
}
