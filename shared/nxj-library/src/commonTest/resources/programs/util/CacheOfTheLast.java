import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedList;
import java.util.Map;

public class CacheOfTheLast<K, V> {
    interface Source<K, V> {
        V of(K key);
    }

    private final Map<K, V> values = new HashMap<K, V>();
    private final LinkedList<K> order = new LinkedList<K>();
    private final Source<? super K, ? extends V> source;
    private final int size;
    int misses;

    CacheOfTheLast(int size, Source<? super K, ? extends V> source) {
        this.size = size;
        this.source = source;
    }

    V get(K key) {
        V value = values.get(key);
        if (value == null) {
            misses++;
            value = source.of(key);
            values.put(key, value);
            if (order.size() == size) values.remove(order.remove(0));
        } else {
            for (Iterator<K> keys = order.iterator(); keys.hasNext();) {
                if (keys.next().equals(key)) keys.remove();
            }
        }
        order.add(key);
        return value;
    }

    public static void main(String[] arguments) {
        CacheOfTheLast<Integer, Long> squares = new CacheOfTheLast<Integer, Long>(3, new Source<Number, Long>() {
            public Long of(Number key) {
                return key.longValue() * key.longValue();
            }
        });
        int[] keys = {1, 2, 3, 1, 4, 1, 2, 5, 100000, 5};
        long sum = 0;
        for (int key : keys) sum += squares.get(key);
        System.out.println(sum + " " + squares.misses + " " + squares.order);
        System.out.println(squares.values.containsKey(2) + " " + squares.values.get(100000));
        // expect 10000000086 7 [2, 100000, 5]
        // expect true 10000000000
    }
}
