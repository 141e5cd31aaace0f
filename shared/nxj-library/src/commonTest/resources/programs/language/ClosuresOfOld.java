public class ClosuresOfOld {
    interface Function<A, B> {
        B apply(A value);
    }

    static <A, B, C> Function<A, C> after(final Function<? super A, ? extends B> first, final Function<? super B, ? extends C> second) {
        return new Function<A, C>() {
            public C apply(A value) {
                return second.apply(first.apply(value));
            }
        };
    }

    static Function<Integer, Integer> adder(final int amount) {
        return new Function<Integer, Integer>() {
            private int uses;

            public Integer apply(Integer value) {
                uses++;
                return value + amount * uses;
            }
        };
    }

    static <A> A times(int count, Function<A, A> function, A value) {
        return count == 0 ? value : times(count - 1, function, function.apply(value));
    }

    public static void main(String[] arguments) {
        Function<Object, Object> text = new Function<Object, Object>() {
            public Object apply(Object value) {
                return "<" + value + ">";
            }
        };
        System.out.println(ClosuresOfOld.<Integer, Integer, Object>after(adder(5), text).apply(37));
        System.out.println(times(4, adder(3), 0));
        System.out.println(ClosuresOfOld.<Object>times(3, ClosuresOfOld.<Object, Object, Object>after(text, text), "x"));
        class Counter {
            int count;

            int next() {
                return ++count;
            }
        }
        final Counter counter = new Counter();
        Runnable twice = new Runnable() {
            public void run() {
                counter.next();
                counter.next();
            }
        };
        twice.run();
        twice.run();
        System.out.println(counter.count);
        // expect <42>
        // expect 30
        // expect <<<<<<x>>>>>>
        // expect 4
    }
}
