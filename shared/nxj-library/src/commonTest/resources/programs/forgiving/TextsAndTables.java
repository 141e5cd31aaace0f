import java.util.BitSet;
import java.util.Date;
import java.util.EmptyStackException;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Hashtable;

public class TextsAndTables {
    public static void main(String[] arguments) {
        String text = "banana";
        System.out.println(text.endsWith("ana") + " " + text.endsWith("ban") + " " + text.lastIndexOf((int) 'n')); // expect true false 4
        System.out.println(text.lastIndexOf((int) 'n', 3) + " " + Integer.signum(-7) + " " + Long.signum(9L)); // expect 2 -1 1
        Hashtable<String, Integer> table = new Hashtable<String, Integer>(4);
        table.put("one", 1);
        table.put("two", 2);
        System.out.println(table.size() + " " + table.containsKey("two") + " " + table.contains(3)); // expect 2 true false
        int sum = 0;
        for (java.util.Enumeration<Integer> all = table.elements(); all.hasMoreElements();) sum += all.nextElement();
        System.out.println(sum + " " + table.remove("two") + " " + table.isEmpty()); // expect 3 2 false
        table.clear();
        System.out.println(table.isEmpty()); // expect true
        BitSet bits = new BitSet();
        BitSet others = new BitSet();
        bits.set(1);
        bits.set(5);
        others.set(5);
        others.set(9);
        System.out.println(bits.intersects(others) + " " + bits.nextSetBit(2) + " " + bits.nextClearBit(1)); // expect true 5 2
        bits.or(others);
        System.out.println(bits); // expect {1, 5, 9}
        bits.andNot(others);
        System.out.println(bits); // expect {1}
        Date date = new Date(5L);
        date.setTime(date.getTime() + 2);
        System.out.println(date.getTime()); // expect 7
        HashMap<String, Integer> map = new HashMap<String, Integer>(8, 0.5f);
        map.put("a", 1);
        HashSet<String> set = new HashSet<String>(8);
        set.add("a");
        System.out.println(map.get("a") + " " + set.contains("a") + " " + new HashSet<String>(8, 0.5f).size()); // expect 1 true 0
        System.out.println(Byte.valueOf((byte) 3).compareTo(Byte.valueOf((byte) 5)) < 0); // expect true
        try {
            Runtime.getRuntime().gc();
            throw new ArrayStoreException("stored");
        } catch (ArrayStoreException wrong) {
            System.out.println(wrong.getMessage()); // expect stored
        }
        System.out.println(new Error(new EmptyStackException()).getCause() instanceof EmptyStackException); // expect true
    }
}
