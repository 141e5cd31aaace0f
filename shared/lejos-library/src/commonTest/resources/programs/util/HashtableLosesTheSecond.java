import java.util.Hashtable;
import josx.platform.rcx.LCD;

public class HashtableLosesTheSecond {
    static class Key {
        private final int number;

        Key(int number) {
            this.number = number;
        }

        public int hashCode() {
            return number;
        }
    }

    public static void main(String[] arguments) {
        Hashtable table = new Hashtable();
        Key first = new Key(3);
        Key second = new Key(35);
        table.put(first, "first");
        table.put(second, "second");
        LCD.showNumber(((String) table.get(first)).length()); // shows: 5
        LCD.showNumber(table.get(second) == null ? 1 : 0); // shows: 1
    }
}
