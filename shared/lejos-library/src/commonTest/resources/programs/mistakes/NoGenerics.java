import java.util.Vector;

public class NoGenerics {
    public static void main(String[] arguments) {
        Vector<String> words = new Vector();
        words.addElement("a");
    }
}
// error 5
