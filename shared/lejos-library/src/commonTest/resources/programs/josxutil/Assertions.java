import josx.platform.rcx.LCD;
import josx.util.Assertion;

public class Assertions {
    public static void main(String[] arguments) {
        Assertion.test("all is well", true);
        Assertion.testEQ("two and two", 4, 2 + 2);
        try {
            Assertion.test("too bad", false);
        } catch (Error wrong) {
            LCD.showNumber(wrong.getMessage().length()); // shows: 7
        }
        Assertion.testEQ("numbers", 1, 2);
    }
}
// fails 13 Error
