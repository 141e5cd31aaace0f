import java.util.EmptyStackException;
import java.util.Stack;
import josx.platform.rcx.LCD;

public class Stacks {
    public static void main(String[] arguments) {
        Stack pile = new Stack();
        LCD.showNumber(pile.empty() ? 1 : 0); // shows: 1
        pile.push("one");
        pile.push("seven");
        LCD.showNumber(((String) pile.peek()).length()); // shows: 5
        LCD.showNumber(pile.search("one")); // shows: 2
        LCD.showNumber(pile.search("seven")); // shows: 1
        LCD.showNumber(-pile.search("none")); // shows: 1
        LCD.showNumber(((String) pile.pop()).length()); // shows: 5
        LCD.showNumber(((String) pile.pop()).length()); // shows: 3
        try {
            pile.pop();
        } catch (EmptyStackException empty) {
            LCD.showNumber(pile.size()); // shows: 0
        }
    }
}
