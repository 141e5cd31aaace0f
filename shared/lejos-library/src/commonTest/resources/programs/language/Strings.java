import josx.platform.rcx.LCD;
import josx.platform.rcx.TextLCD;

public class Strings {
    public static void main(String[] arguments) {
        String word = "LEGO";
        LCD.showNumber(word.length()); // shows: 4
        LCD.showNumber(word.charAt(1)); // shows: 69
        TextLCD.print(word); // shows: LEGO
        TextLCD.print("A" + 1 + true); // shows: A1tru
        TextLCD.print("x" + 'y' + 2.5f); // shows: xy2.5
        TextLCD.print(1 + 2 + "n" + 1 + 2); // shows: 3n12
        TextLCD.print('c' + "d"); // shows: cd
        String empty = null;
        TextLCD.print("" + empty); // shows: null
        String joined = "LE";
        joined += "GO";
        LCD.showNumber(joined.equals(word) ? 1 : 0); // shows: 1
        LCD.showNumber(joined.equals("lego") ? 1 : 0); // shows: 0
        LCD.showNumber(joined.equals(null) ? 1 : 0); // shows: 0
        LCD.showNumber(joined == word ? 1 : 0); // shows: 0
    }
}
