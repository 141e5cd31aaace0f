import josx.platform.rcx.LCD;
import josx.platform.rcx.TextLCD;

public class StringBuilders {
    public static void main(String[] arguments) {
        StringBuilder text = new StringBuilder();
        text.append('a').append("b").append(true).append(3).append(4L).append(0.5f).append(1.5).append((Object) null);
        LCD.showNumber(text.length()); // shows: 18
        text.delete(2, 6);
        TextLCD.print(text.toString()); // shows: ab340
        LCD.showNumber(text.charAt(2)); // shows: 51
        LCD.showNumber(text.getChars().length); // shows: 14
        LCD.showNumber(StringUtils.getCharacters(-0.25f).length); // shows: 5
    }
}
