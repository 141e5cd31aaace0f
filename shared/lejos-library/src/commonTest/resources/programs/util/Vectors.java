import java.util.Vector;
import josx.platform.rcx.LCD;

public class Vectors {
    public static void main(String[] arguments) {
        Vector list = new Vector(2);
        LCD.showNumber(list.isEmpty() ? 1 : 0); // shows: 1
        list.addElement("a");
        list.addElement("c");
        list.insertElementAt("b", 1);
        list.addElement("a");
        LCD.showNumber(list.size()); // shows: 4
        LCD.showNumber(list.capacity()); // shows: 4
        LCD.showNumber(((String) list.elementAt(1)).charAt(0)); // shows: 98
        LCD.showNumber(list.indexOf("a")); // shows: 0
        LCD.showNumber(list.indexOf("a", 1)); // shows: 3
        LCD.showNumber(list.lastIndexOf("a")); // shows: 3
        LCD.showNumber(list.lastIndexOf("a", 2)); // shows: 0
        LCD.showNumber(-list.indexOf("x")); // shows: 1
        list.setElementAt("z", 3);
        LCD.showNumber(list.removeElement("c") ? 1 : 0); // shows: 1
        LCD.showNumber(list.removeElement("c") ? 1 : 0); // shows: 0
        list.removeElementAt(0);
        LCD.showNumber(((String) list.elementAt(1)).charAt(0)); // shows: 122
        LCD.showNumber(list.toArray().length); // shows: 2
        list.trimToSize();
        LCD.showNumber(list.capacity()); // shows: 2
        list.ensureCapacity(10);
        LCD.showNumber(list.capacity()); // shows: 10
        list.setSize(3);
        LCD.showNumber(list.elementAt(2) == null ? 1 : 0); // shows: 1
        LCD.showNumber(list.indexOf(null)); // shows: 2
        list.removeAllElements();
        LCD.showNumber(list.size()); // shows: 0
        list.addElement(list);
        list.clear();
        LCD.showNumber(list.equals(list) ? 1 : 0); // shows: 1
        try {
            list.elementAt(0);
        } catch (ArrayIndexOutOfBoundsException none) {
            LCD.showNumber(8); // shows: 8
        }
        LCD.showNumber(new Vector(3, 5).capacity() + new Vector().capacity()); // shows: 10
    }
}
