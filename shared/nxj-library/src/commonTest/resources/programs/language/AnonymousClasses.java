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
        System.out.println(apply(triple, 10)); // expect 41
        System.out.println(apply(triple, 10)); // expect 42
        class Local implements Rule {
            public int apply(int number) {
                return number - factor;
            }
        }
        System.out.println(apply(new Local(), 10)); // expect 6
    }
}
