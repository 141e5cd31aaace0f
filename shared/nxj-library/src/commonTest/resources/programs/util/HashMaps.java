import java.util.HashMap;
import java.util.HashSet;
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
        System.out.println(counts.size() + " " + counts.containsKey("b") + " " + counts.containsKey("d")); // expect 3 true false
        System.out.println(counts.remove("b") + " " + counts.remove("b") + " " + counts.size()); // expect 2 null 2
        Map<Integer, String> many = new HashMap<Integer, String>();
        for (int i = 0; i < 100; i++) many.put(i * 17, "v" + i);
        System.out.println(many.size() + " " + many.get(17 * 42) + " " + many.get(1)); // expect 100 v42 null
        for (int i = 1; i < 100; i += 2) many.remove(i * 17);
        System.out.println(many.size() + " " + many.get(17 * 42) + " " + many.get(17 * 43)); // expect 50 v42 null
        many.put(17 * 43, null);
        System.out.println(many.size() + " " + many.containsKey(17 * 43)); // expect 51 true
        Set<String> set = new HashSet<String>();
        System.out.println(set.add("x") + " " + set.add("x") + " " + set.contains("x") + " " + set.remove("y") + " " + set.size());
        // expect true false true false 1
        Set<Object> mixed = new HashSet<Object>();
        mixed.add(1);
        mixed.add(1L);
        mixed.add(1.0);
        mixed.add("1");
        System.out.println(mixed.size()); // expect 4
        mixed.clear();
        System.out.println(mixed.isEmpty() + " " + mixed.contains(1)); // expect true false
        System.out.println(counts.equals(counts) + " " + counts.equals(many)); // expect true false
        counts.clear();
        System.out.println(counts.isEmpty() + " " + counts.get("a")); // expect true null
    }
}
