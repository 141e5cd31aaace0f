import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;

public class Generics {
    static class Pair<A extends Comparable<A>, B> {
        final A first;
        final B second;

        Pair(A first, B second) {
            this.first = first;
            this.second = second;
        }

        <C> Pair<A, C> with(C other) {
            return new Pair<A, C>(first, other);
        }

        boolean isBefore(Pair<A, ?> other) {
            return first.compareTo(other.first) < 0;
        }

        @Override
        public String toString() {
            return first + ":" + second;
        }
    }

    static class Countdown implements Iterable<Integer> {
        private final int from;

        Countdown(int from) {
            this.from = from;
        }

        public Iterator<Integer> iterator() {
            return new Iterator<Integer>() {
                private int next = from;

                public boolean hasNext() {
                    return next > 0;
                }

                public Integer next() {
                    return next--;
                }

                public void remove() {
                    throw new UnsupportedOperationException();
                }
            };
        }
    }

    abstract static class Maker<T> {
        abstract T make(T part);

        T twice(T part) {
            return make(make(part));
        }
    }

    static class Doubler extends Maker<String> {
        @Override
        String make(String part) {
            return part + part;
        }
    }

    static <T extends Comparable<? super T>> T largest(Iterable<? extends T> all) {
        T best = null;
        for (T one : all) {
            if (best == null || one.compareTo(best) > 0) best = one;
        }
        return best;
    }

    static double sum(List<? extends Number> numbers) {
        double sum = 0;
        for (Number number : numbers) sum += number.doubleValue();
        return sum;
    }

    static <T> void fill(List<? super T> list, T value, int count) {
        for (int i = 0; i < count; i++) list.add(value);
    }

    public static void main(String[] arguments) {
        Pair<String, Integer> pair = new Pair<String, Integer>("b", 3);
        System.out.println(pair); // expect b:3
        System.out.println(pair.with(2.5)); // expect b:2.5
        System.out.println(pair.isBefore(new Pair<String, Object>("c", null))); // expect true
        int sum = 0;
        for (int number : new Countdown(4)) sum = sum * 10 + number;
        System.out.println(sum); // expect 4321
        System.out.println(new Doubler().twice("ab")); // expect abababab
        Maker<String> maker = new Doubler();
        System.out.println(maker.make("x")); // expect xx
        List<Integer> numbers = new ArrayList<Integer>();
        numbers.add(3);
        numbers.add(11);
        numbers.add(7);
        System.out.println(largest(numbers)); // expect 11
        System.out.println(sum(numbers)); // expect 21.0
        List<Object> objects = new ArrayList<Object>();
        Generics.<String>fill(objects, "z", 3);
        fill(objects, 1, 1);
        System.out.println(objects); // expect [z, z, z, 1]
        @SuppressWarnings({"unchecked", "rawtypes"})
        List<String> wrong = (List) numbers;
        try {
            String text = wrong.get(0);
            System.out.println(text);
        } catch (ClassCastException cast) {
            System.out.println("no text"); // expect no text
        }
    }
}
