import josx.platform.rcx.LCD;
import josx.platform.rcx.TextLCD;

public class Texts {
    public static void main(String[] arguments) {
        TextLCD.print("HELLO"); // shows: HELLO
        TextLCD.print("Hi"); // shows: Hi
        TextLCD.print("too long"); // shows: too_l
        TextLCD.print("0-9"); // shows: 0-9
        TextLCD.print(new char[] {'A', 'b'}); // shows: Ab
        TextLCD.print(""); // shows: _
        TextLCD.printChar('x', 4);
        TextLCD.printChar('y', 0);
        LCD.refresh(); // shows: x___y
        try {
            TextLCD.printChar('\u00e4', 0);
        } catch (ArrayIndexOutOfBoundsException noShape) {
            TextLCD.print("NO"); // shows: NO
        }
    }
}
