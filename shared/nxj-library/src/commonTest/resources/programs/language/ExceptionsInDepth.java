public class ExceptionsInDepth {
    static class Trouble extends Exception {
        private final int level;

        Trouble(String message, int level, Throwable cause) {
            super(message, cause);
            this.level = level;
        }
    }

    static int depth(int level) throws Trouble {
        try {
            if (level == 0) throw new IllegalStateException("bottom");
            return depth(level - 1) + 1;
        } catch (IllegalStateException wrong) {
            throw new Trouble("at " + level, level, wrong);
        } finally {
            System.out.println("leaving " + level); // prints: leaving 0 | leaving 1 | leaving 2
        }
    }

    static int returns() {
        int value = 1;
        try {
            value = 2;
            return value;
        } finally {
            value = 3;
        }
    }

    @SuppressWarnings("finally")
    static int hides() {
        try {
            throw new RuntimeException("hidden");
        } finally {
            return 4;
        }
    }

    public static void main(String[] arguments) {
        try {
            depth(2);
        } catch (Trouble trouble) {
            System.out.println(trouble.getMessage() + " " + trouble.level); // prints: at 0 0
            System.out.println(trouble.getCause().getMessage()); // prints: bottom
            System.out.println(trouble.getCause().getCause() == null); // prints: true
        }
        System.out.println(returns() + " " + hides()); // prints: 2 4
        try {
            Object text = "text";
            System.out.println((Integer) text);
        } catch (ClassCastException wrong) {
            System.out.println("cast"); // prints: cast
        }
        try {
            Object[] texts = new String[1];
            texts[0] = 3;
        } catch (ArrayStoreException wrong) {
            System.out.println("store"); // prints: store
        }
        try {
            System.out.println(new int[-1].length);
        } catch (NegativeArraySizeException wrong) {
            System.out.println("size"); // prints: size
        }
        try {
            System.out.println(1 / (arguments.length));
        } catch (ArithmeticException wrong) {
            System.out.println("zero"); // prints: zero
        }
        try {
            System.out.println(1L % arguments.length);
        } catch (ArithmeticException wrong) {
            System.out.println("zero too"); // prints: zero too
        }
        try {
            throw null;
        } catch (NullPointerException wrong) {
            System.out.println("null"); // prints: null
        }
        try {
            deep(0);
        } catch (StackOverflowError wrong) {
            System.out.println("too deep"); // prints: too deep
        }
        try {
            try {
                throw new IllegalArgumentException("first");
            } finally {
                System.out.println("between"); // prints: between
            }
        } catch (RuntimeException wrong) {
            System.out.println(wrong.getMessage()); // prints: first
        }
    }

    static int deep(int level) {
        return deep(level + 1) + 1;
    }
}
