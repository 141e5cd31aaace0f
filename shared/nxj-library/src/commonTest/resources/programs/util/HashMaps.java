import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.Map;
import java.util.Set;

public class HashMaps {
    public static void main(String[] arguments) {
        Map<String, Integer> counts = new HashMap<String, Integer>();
        for (String word : new String[] {"a", "b", "a", "c", "b", "a"}) {
            Integer count = counts.get(word);
            counts.put(word, count == null ? 1 : count + 1);
        }
        System.out.println(counts.get("a") + " " + counts.get("b") + " " + counts.get("c") + " " + counts.get("d")); // expect 3 2 1 null
        System.out.println(counts.size() + " " + counts.containsKey("b") + " " + counts.containsValue(3) + " " + counts.containsValue(4));
        // expect 3 true true false
        int sum = 0;
        for (Map.Entry<String, Integer> entry : counts.entrySet()) sum += entry.getValue() * entry.getKey().charAt(0);
        System.out.println(sum); // expect 586
        System.out.println(counts.remove("b") + " " + counts.remove("b") + " " + counts.size()); // expect 2 null 2
        Map<Integer, String> many = new HashMap<Integer, String>();
        for (int i = 0; i < 100; i++) many.put(i * 17, "v" + i);
        System.out.println(many.size() + " " + many.get(17 * 42) + " " + many.get(1)); // expect 100 v42 null
        for (Iterator<Integer> keys = many.keySet().iterator(); keys.hasNext();) {
            if (keys.next() % 2 == 1) keys.remove();
        }
        System.out.println(many.size()); // expect 50
        many.put(null, "null key");
        System.out.println(many.get(null)); // expect null key
        Set<String> set = new HashSet<String>();
        System.out.println(set.add("x") + " " + set.add("x") + " " + set.contains("x") + " " + set.remove("y") + " " + set.size());
        // expect true false true false 1
        Set<Object> mixed = new HashSet<Object>();
        mixed.add(1);
        mixed.add(1L);
        mixed.add(1.0);
        mixed.add("1");
        System.out.println(mixed.size()); // expect 4
        Map<String, Integer> same = new HashMap<String, Integer>(counts);
        System.out.println(same.equals(counts) + " " + (same.hashCode() == counts.hashCode())); // expect true true
        counts.clear();
        System.out.println(counts.isEmpty() + " " + counts); // expect true {}
    }
}
