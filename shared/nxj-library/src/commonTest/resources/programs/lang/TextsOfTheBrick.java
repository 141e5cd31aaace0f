// only here
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;

/** What a brick does in its own way with texts, objects and exceptions as texts. */
public class TextsOfTheBrick {
    static class Told extends Exception {
        Told(String text, Throwable cause) {
            super(text, cause);
        }
    }

    public static void main(String[] arguments) {
        System.out.println("apple".compareTo("apricot") + " " + "b".compareTo("a") + " " + "ab".compareTo("abcd")); // expect -1 1 -1
        try {
            System.out.println("a".concat(""));
        } catch (ArrayIndexOutOfBoundsException wrong) {
            System.out.println(wrong); // expect class 28
        }
        try {
            "abc".charAt(3);
        } catch (ArrayIndexOutOfBoundsException wrong) {
            System.out.println(wrong.getMessage()); // expect null
        }
        try {
            "abc".charAt(4);
        } catch (StringIndexOutOfBoundsException wrong) {
            System.out.println("outside"); // expect outside
        }
        System.out.println(new Object().toString().startsWith("Object@")); // expect true
        System.out.println(new TextsOfTheBrick().toString().startsWith("Object@")); // expect true
        System.out.println(new int[0].toString().startsWith("Object@")); // expect true
        System.out.println(Runnable.class.toString().startsWith("interface ")); // expect true
        System.out.println(Object.class); // expect class 0
        try {
            System.out.println(1 / arguments.length);
        } catch (ArithmeticException wrong) {
            System.out.println(wrong); // expect class 27
        }
        System.out.println(new IllegalArgumentException("five")); // expect class 29: five
        Throwable told = new Error(new IllegalStateException("no").toString());
        System.out.println(told); // expect class 2: class 31: no
        System.out.println(new RuntimeException(new NullPointerException()).getMessage()); // expect class 16
        try {
            told.initCause(told);
        } catch (IllegalArgumentException wrong) {
            System.out.println("itself"); // expect itself
        }
        told.initCause(new Error());
        try {
            told.initCause(new Error());
        } catch (IllegalStateException wrong) {
            System.out.println("again"); // expect again
        }
        printed();
    }

    /** The rows of printStackTrace: numbers are not padded. */
    static void printed() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        Error cause = new Error("cause");
        new Told("told", cause).printStackTrace(new PrintStream(bytes));
        String text = bytes.toString();
        System.out.println(text.startsWith("class ") + " " + text.indexOf(": told\n at: ")); // expect true 8
        String call = text.substring(text.indexOf(" at: ") + 5, text.indexOf('\n', 20));
        boolean isShort = call.charAt(0) > '0' && call.charAt(0) <= '9' && call.indexOf(' ') < 0;
        System.out.println(isShort + " " + (call.indexOf(':') > 0)); // expect true true
        System.out.println(text.indexOf("\nCaused by: class 2: cause\n at: ") > 0); // expect true
    }
}
