import java.util.Enumeration;
import java.util.Hashtable;

// only here
public class KeysOfAHashtable {
    /** The keys are in the order of 32 places, those of the same place in the order in which they came. */
    public static void main(String[] arguments) {
        Hashtable<Integer, String> table = new Hashtable<Integer, String>();
        int[] keys = {40, 3, 8, -1, 35, 100, 72};
        for (int key : keys) table.put(key, "v" + key);
        table.put(8, null);
        StringBuilder order = new StringBuilder();
        Enumeration<Integer> all = table.keys();
        while (all.hasMoreElements()) {
            int key = all.nextElement();
            order.append(key).append(table.get(key) == null ? "! " : " ");
        }
        System.out.println(order.toString().trim()); // expect 3 35 100 40 8! 72 -1
        System.out.println(all.nextElement()); // expect null
        try {
            table.put(null, "x");
        } catch (NullPointerException wrong) {
            System.out.println("no key"); // expect no key
        }
    }
}
