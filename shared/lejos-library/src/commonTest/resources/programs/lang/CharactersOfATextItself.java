import josx.platform.rcx.LCD;
import josx.platform.rcx.TextLCD;

public class CharactersOfATextItself {
    public static void main(String[] arguments) {
        String text = new StringBuffer("HALLO").toString();
        char[] characters = StringUtils.getCharacters(text);
        LCD.showNumber(characters.length); // shows: 5
        characters[1] = 'E';
        TextLCD.print(text); // shows: HELLO
        LCD.showNumber(text.toCharArray() == characters ? 1 : 0); // shows: 0
        LCD.showNumber(StringUtils.getCharacters(text) == characters ? 1 : 0); // shows: 1
    }
}
