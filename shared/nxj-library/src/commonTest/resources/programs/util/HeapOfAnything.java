import java.util.ArrayList;
import java.util.Iterator;
import java.util.NoSuchElementException;

public class HeapOfAnything<T extends Comparable<? super T>> implements Iterable<T> {
    private final ArrayList<T> items = new ArrayList<T>();

    void add(T item) {
        int place = items.size();
        items.add(item);
        while (place > 0 && items.get((place - 1) / 2).compareTo(item) > 0) {
            items.set(place, items.get((place - 1) / 2));
            place = (place - 1) / 2;
        }
        items.set(place, item);
    }

    T remove() {
        if (items.isEmpty()) throw new NoSuchElementException();
        T least = items.get(0);
        T last = items.remove(items.size() - 1);
        if (items.isEmpty()) return least;
        int place = 0;
        while (2 * place + 1 < items.size()) {
            int child = 2 * place + 1;
            if (child + 1 < items.size() && items.get(child + 1).compareTo(items.get(child)) < 0) child++;
            if (last.compareTo(items.get(child)) <= 0) break;
            items.set(place, items.get(child));
            place = child;
        }
        items.set(place, last);
        return least;
    }

    public Iterator<T> iterator() {
        return new Iterator<T>() {
            public boolean hasNext() {
                return !items.isEmpty();
            }

            public T next() {
                return HeapOfAnything.this.remove();
            }

            public void remove() {
                throw new UnsupportedOperationException();
            }
        };
    }

    public static void main(String[] arguments) {
        HeapOfAnything<Integer> numbers = new HeapOfAnything<Integer>();
        for (int i = 0; i < 12; i++) numbers.add(i * 7 % 12);
        StringBuilder text = new StringBuilder();
        for (int number : numbers) text.append(number).append(' ');
        System.out.println(text.toString().trim());
        HeapOfAnything<String> words = new HeapOfAnything<String>();
        for (String word : new String[] {"sonar", "motor", "button", "display", "light"}) words.add(word);
        System.out.println(words.remove() + " " + words.remove());
        try {
            numbers.remove();
        } catch (NoSuchElementException nothing) {
            System.out.println("empty");
        }
        // expect 0 1 2 3 4 5 6 7 8 9 10 11
        // expect button display
        // expect empty
    }
}
