import java.util.Vector;

public class NoBoxes {
    public static void main(String[] arguments) {
        Vector numbers = new Vector();
        numbers.addElement(5);
        Double decimal = new Double(2.5);
    }
}
// error 6
// error 7
