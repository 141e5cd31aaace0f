import java.util.Hashtable;
import josx.platform.rcx.LCD;

public class Hashtables {
    static class Key {
        private final int number;

        Key(int number) {
            this.number = number;
        }

        public boolean equals(Object other) {
            return other instanceof Key && ((Key) other).number == number;
        }

        public int hashCode() {
            return number;
        }
    }

    static int length(Object text) {
        return text == null ? 0 : ((String) text).length();
    }

    public static void main(String[] arguments) {
        Hashtable table = new Hashtable();
        table.put(new Key(1), "one");
        table.put(new Key(3), "three");
        LCD.showNumber(length(table.get(new Key(1)))); // shows: 3
        LCD.showNumber(length(table.get(new Key(3)))); // shows: 5
        LCD.showNumber(length(table.get(new Key(2)))); // shows: 0
        table.put(new Key(1), "first");
        LCD.showNumber(length(table.get(new Key(1)))); // shows: 5
    }
}
