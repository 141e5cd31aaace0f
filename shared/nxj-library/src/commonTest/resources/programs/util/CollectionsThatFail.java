// only here
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** On a brick, nothing goes through a map or a set. */
public class CollectionsThatFail {
    interface Try {
        Object run();
    }

    static void fails(Try attempt) {
        try {
            System.out.println(attempt.run());
        } catch (UnsupportedOperationException wrong) {
            System.out.println("unsupported " + wrong.getMessage());
        } catch (ArrayIndexOutOfBoundsException wrong) {
            System.out.println("index");
        } catch (NullPointerException wrong) {
            System.out.println("null");
        }
    }

    public static void main(String[] arguments) {
        final Map<String, Integer> map = new HashMap<String, Integer>();
        map.put("a", 1);
        final Set<String> set = new HashSet<String>();
        set.add("a");
        final Try[] attempts = {
            new Try() { public Object run() { return map.keySet(); } }, // expect unsupported null
            new Try() { public Object run() { return map.values(); } }, // expect unsupported null
            new Try() { public Object run() { return map.entrySet(); } }, // expect unsupported null
            new Try() { public Object run() { return map.containsValue(1); } }, // expect unsupported null
            new Try() { public Object run() { return map.hashCode(); } }, // expect unsupported null
            new Try() { public Object run() { return new HashMap<String, Integer>(map); } }, // expect unsupported null
            new Try() { public Object run() { return set.iterator(); } }, // expect unsupported null
            new Try() { public Object run() { return set.toArray(); } }, // expect unsupported null
            new Try() { public Object run() { return new ArrayList<String>(set); } }, // expect unsupported null
            new Try() { public Object run() { return map.get(null); } }, // expect null
            new Try() { public Object run() { return set.add(null); } }, // expect null
            new Try() { public Object run() { return map.put("Robotran", 2); } }, // expect index
            new Try() { public Object run() { return map.get("robot") + " " + map.size(); } }, // expect null 1
            new Try() { public Object run() { return set.contains("a") + " " + set.size(); } }, // expect true 1
            new Try() { public Object run() { return subList(); } }, // expect unsupported null
        };
        for (Try attempt : attempts) fails(attempt);
        try {
            for (String text : set) System.out.println(text);
        } catch (UnsupportedOperationException wrong) {
            System.out.println("no loop"); // expect no loop
        }
    }

    static List<Integer> subList() {
        List<Integer> list = new ArrayList<Integer>();
        list.add(1);
        return list.subList(0, 1);
    }
}
