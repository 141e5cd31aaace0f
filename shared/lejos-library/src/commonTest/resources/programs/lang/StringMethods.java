import josx.platform.rcx.LCD;
import josx.platform.rcx.TextLCD;

public class StringMethods {
    public static void main(String[] arguments) {
        char[] letters = {'R', 'o', 'b', 'o', 't'};
        String word = new String(letters, 1, 3);
        letters[1] = 'x';
        LCD.showNumber(word.length()); // shows: 3
        LCD.showNumber(word.charAt(0)); // shows: 111
        TextLCD.print(word); // shows: obo
        char[] copy = word.toCharArray();
        copy[0] = 'X';
        TextLCD.print(word.toString()); // shows: obo
        TextLCD.print(String.valueOf(new Integer(-7))); // shows: -7
        TextLCD.print(String.valueOf((Object) null)); // shows: null
        LCD.showNumber(word.equals("obo") ? 1 : 0); // shows: 1
        LCD.showNumber(word.equals(new Integer(1)) ? 1 : 0); // shows: 0
        try {
            word.charAt(3);
        } catch (ArrayIndexOutOfBoundsException tooFar) {
            LCD.showNumber(9); // shows: 9
        }
    }
}
