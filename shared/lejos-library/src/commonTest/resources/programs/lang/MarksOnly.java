import java.io.Serializable;
import josx.platform.rcx.LCD;

public class MarksOnly implements Cloneable, Serializable {
    public static void main(String[] arguments) {
        Object marked = new MarksOnly();
        LCD.showNumber(marked instanceof Cloneable && marked instanceof Serializable ? 1 : 0); // shows: 1
    }
}
