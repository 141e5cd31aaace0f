// only here
import java.util.NoSuchElementException;
import java.util.StringTokenizer;

/** All characters that separate words stand for one sign together, and there are empty words. */
public class TokensOfTheBrick {
    static void show(StringTokenizer words) {
        String shown = words.countTokens() + ":";
        while (words.hasMoreTokens()) shown += " [" + words.nextToken() + "]";
        System.out.println(shown);
    }

    public static void main(String[] arguments) {
        show(new StringTokenizer("one,two three")); // expect 2: [one] [two three]
        show(new StringTokenizer("1;2,3;,4", ";,")); // expect 2: [1;2,3] [,4]
        show(new StringTokenizer("a  b ", " ")); // expect 4: [a] [] [b] []
        StringTokenizer words = new StringTokenizer("x", ";");
        System.out.println(words.nextElement() + " " + words.nextElement()); // expect x null
        try {
            words.nextToken();
        } catch (NoSuchElementException wrong) {
            System.out.println("no more"); // expect no more
        }
        try {
            new StringTokenizer("");
        } catch (StringIndexOutOfBoundsException wrong) {
            System.out.println("empty"); // expect empty
        }
    }
}
