import josx.platform.rcx.LCD;
import josx.platform.rcx.TextLCD;

public class StringBuffers {
    public static void main(String[] arguments) {
        StringBuffer text = new StringBuffer();
        LCD.showNumber(text.length()); // shows: 0
        text.append("ab").append('c').append(4).append(true);
        TextLCD.print(text.toString()); // shows: abc4t
        LCD.showNumber(text.length()); // shows: 8
        LCD.showNumber(text.charAt(3)); // shows: 52
        text.delete(1, 7);
        TextLCD.print(text.getChars()); // shows: ae
        text.append((Object) null).append(new Integer(5)).append(6L).append(1.5f).append(0.25);
        LCD.showNumber(text.length()); // shows: 15
        text.delete(0, 6);
        TextLCD.print(text.toString()); // shows: 561.5
        text.delete(0, 100);
        LCD.showNumber(text.length()); // shows: 0
        TextLCD.print(new StringBuffer(3).append(-12).append('a').toString()); // shows: -12a
        StringBuffer grown = new StringBuffer("");
        for (int times = 0; times < 50; times++) grown.append("xyz");
        LCD.showNumber(grown.length()); // shows: 150
        LCD.showNumber(grown.charAt(149)); // shows: 122
        StringBuilder builder = new StringBuilder("a").append(1);
        TextLCD.print(builder.toString()); // shows: a1
    }
}
