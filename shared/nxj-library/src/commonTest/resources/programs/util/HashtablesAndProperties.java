import java.util.Enumeration;
import java.util.Hashtable;
import java.util.Properties;

public class HashtablesAndProperties {
    public static void main(String[] arguments) {
        Hashtable<String, Integer> table = new Hashtable<String, Integer>();
        table.put("one", 1);
        table.put("two", 2);
        System.out.println(table.put("one", 11) + " " + table.get("one") + " " + table.get("three")); // expect 1 11 null
        int sum = 0;
        for (Enumeration<String> all = table.keys(); all.hasMoreElements();) sum += table.get(all.nextElement());
        System.out.println(sum); // expect 13
        Properties settings = new Properties();
        settings.setProperty("speed", "20");
        System.out.println(settings.getProperty("speed") + " " + settings.getProperty("none") + " " + settings.getProperty("none", "7")); // expect 20 null 7
    }
}
