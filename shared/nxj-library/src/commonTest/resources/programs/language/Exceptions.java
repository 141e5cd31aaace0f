/** What is thrown, caught and done anyway. */
public class Exceptions {
    static class Own extends Exception {
        Own(String message, Throwable cause) { super(message, cause); }
    }

    static int depth;

    public static void main(String[] args) {
        System.out.println(order(1) + " " + order(0)); // expect 11113 1001
        try {
            deep(0);
        } catch (Own own) {
            System.out.println(own.getMessage() + " " + own.getCause().getMessage()); // expect outer inner
        }
        try {
            endless();
        } catch (StackOverflowError e) {
            System.out.println(depth > 50); // expect true
        }
        try {
            int[] numbers = new int[3];
            numbers[3] = 1;
        } catch (ArrayIndexOutOfBoundsException e) {
            System.out.println("index"); // expect index
        }
        try {
            Object nothing = null;
            nothing.hashCode();
        } catch (NullPointerException e) {
            System.out.println("null"); // expect null
        }
        synchronized (Exceptions.class) {
            System.out.println(locked()); // expect 4
        }
        int[] none = null;
        System.out.println(none.length); // fails NullPointerException
    }

    static synchronized int locked() {
        return 4;
    }

    static int order(int divisor) {
        int result = 1000;
        try {
            result += 10 / divisor;
        } catch (ArithmeticException e) {
            result += 1;
            return result;
        } finally {
            result += 2;
            System.out.print("");
        }
        return result + 10101;
    }

    static void deep(int level) throws Own {
        try {
            if (level == 3) throw new IllegalStateException("inner");
            deep(level + 1);
        } catch (IllegalStateException e) {
            throw new Own("outer", e);
        }
    }

    static void endless() {
        depth++;
        endless();
    }
}
