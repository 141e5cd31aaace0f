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
            System.out.println("leaving " + level); // expect leaving 0
            // expect leaving 1
            // expect leaving 2
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
            System.out.println(trouble.getMessage() + " " + trouble.level); // expect at 0 0
            System.out.println(trouble.getCause().getMessage()); // expect bottom
            System.out.println(trouble.getCause().getCause() == null); // expect true
        }
        System.out.println(returns() + " " + hides()); // expect 2 4
        try {
            Object text = "text";
            System.out.println((Integer) text);
        } catch (ClassCastException wrong) {
            System.out.println("cast"); // expect cast
        }
        try {
            System.arraycopy(new int[1], 0, new long[1], 0, 1);
        } catch (ArrayStoreException wrong) {
            System.out.println("store"); // expect store
        }
        try {
            System.out.println(new int[-1].length);
        } catch (NegativeArraySizeException wrong) {
            System.out.println("size"); // expect size
        }
        try {
            System.out.println(1 / (arguments.length));
        } catch (ArithmeticException wrong) {
            System.out.println("zero"); // expect zero
        }
        try {
            System.out.println(1L % arguments.length);
        } catch (ArithmeticException wrong) {
            System.out.println("zero too"); // expect zero too
        }
        try {
            throw null;
        } catch (NullPointerException wrong) {
            System.out.println("null"); // expect null
        }
        try {
            deep(0);
        } catch (StackOverflowError wrong) {
            System.out.println("too deep"); // expect too deep
        }
        try {
            try {
                throw new IllegalArgumentException("first");
            } finally {
                System.out.println("between"); // expect between
            }
        } catch (RuntimeException wrong) {
            System.out.println(wrong.getMessage()); // expect first
        }
    }

    static int deep(int level) {
        return deep(level + 1) + 1;
    }
}
