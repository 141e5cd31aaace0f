import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedList;
import java.util.List;
import java.util.Map;

public class EventsInOrder {
    static class Event implements Comparable<Event> {
        final long time;
        final String what;

        Event(long time, String what) {
            this.time = time;
            this.what = what;
        }

        public int compareTo(Event other) {
            return time < other.time ? -1 : time > other.time ? 1 : what.compareTo(other.what);
        }
    }

    /** A heap: the smallest comes first. */
    static class Heap<T extends Comparable<? super T>> {
        private final List<T> items = new ArrayList<T>();

        void add(T item) {
            items.add(item);
            int place = items.size() - 1;
            while (place > 0 && items.get((place - 1) / 2).compareTo(items.get(place)) > 0) {
                swap(place, (place - 1) / 2);
                place = (place - 1) / 2;
            }
        }

        T take() {
            T first = items.get(0);
            T last = items.remove(items.size() - 1);
            if (items.isEmpty()) return first;
            items.set(0, last);
            int place = 0;
            while (true) {
                int smallest = place;
                for (int child = 2 * place + 1; child <= 2 * place + 2 && child < items.size(); child++) {
                    if (items.get(child).compareTo(items.get(smallest)) < 0) smallest = child;
                }
                if (smallest == place) return first;
                swap(place, smallest);
                place = smallest;
            }
        }

        boolean isEmpty() {
            return items.isEmpty();
        }

        private void swap(int a, int b) {
            T item = items.get(a);
            items.set(a, items.get(b));
            items.set(b, item);
        }
    }

    public static void main(String[] arguments) {
        Heap<Event> heap = new Heap<Event>();
        String[] names = {"go", "turn", "stop", "beep"};
        for (int i = 0; i < 12; i++) heap.add(new Event((i * 7919L) % 50, names[i % 4]));
        StringBuilder order = new StringBuilder();
        Map<String, Integer> last = new HashMap<String, Integer>();
        int count = 0;
        while (!heap.isEmpty()) {
            Event event = heap.take();
            order.append(event.time).append(event.what.charAt(0)).append(' ');
            last.put(event.what, count++);
        }
        System.out.println(order.toString().trim()); // expect 0g 2g 7b 9b 14s 19t 21t 26g 33b 38s 40s 45t
        System.out.println(last.get("go") + " " + last.get("turn") + " " + last.get("stop") + " " + last.get("beep")); // expect 7 11 10 8
        LinkedList<Integer> waiting = new LinkedList<Integer>();
        for (int i = 1; i <= 7; i++) waiting.add(i);
        String out = "";
        while (waiting.size() > 1) {
            waiting.add(waiting.remove(0));
            waiting.add(waiting.remove(0));
            out += waiting.remove(0) + " ";
        }
        System.out.println(out + waiting.get(0)); // expect 3 6 2 7 5 1 4
    }
}
