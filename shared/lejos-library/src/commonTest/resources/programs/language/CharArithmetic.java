import josx.platform.rcx.LCD;

public class CharArithmetic {
    public static void main(String[] arguments) {
        char letter = 'A';
        LCD.showNumber(letter); // shows: 65
        letter++;
        LCD.showNumber(letter); // shows: 66
        letter += 2;
        LCD.showNumber(letter - 'A'); // shows: 3
        LCD.showNumber((char) (letter + 256)); // shows: 324
        LCD.showNumber('0' + 7); // shows: 55
        LCD.showNumber(letter == 'D' ? 1 : 0); // shows: 1
        LCD.showNumber('\n'); // shows: 10
        LCD.showNumber('\u00e4'); // shows: 228
    }
}
