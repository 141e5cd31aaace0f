// screen 0: line 7
// screen 1: line 8
// screen 2: line 9
// screen 3: a long line that
// screen 4:  wraps
// screen 5: x=7.0 1234567890
// screen 6: 123
// nxj only
public class LinesScroll {
    public static void main(String[] arguments) {
        for (int line = 0; line < 10; line++) System.out.println("line " + line); // prints: line 0 | line 1 | line 2 | line 3 | line 4 | line 5 | line 6 | line 7 | line 8 | line 9
        System.out.println("a long line that wraps"); // prints: a long line that wraps
        System.out.println("x=" + 3.5f * 2 + " " + 1234567890123L); // prints: x=7.0 1234567890123
    }
}
