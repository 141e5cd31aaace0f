public class InitialisationOrder {
    static String log = "";

    static int note(String text, int value) {
        log += text + " ";
        return value;
    }

    static class First {
        static int a = note("First.a", 1);
        int b = note("b", 2);

        static {
            note("First.static", 0);
        }

        {
            note("block", 0);
        }

        First() {
            note("First()", 0);
        }
    }

    static class Second extends First {
        static int c = note("Second.c", 3);
        int d = note("d", 4);

        Second() {
            this(note("argument", 5));
            note("Second()", 0);
        }

        Second(int value) {
            super();
            note("Second(int)", 0);
        }
    }

    static class Constants {
        static final int FIXED = 7;
        static final String TEXT = "fixed";
        static final int MADE = note("Constants", 8);
    }

    public static void main(String[] arguments) {
        System.out.println(Constants.FIXED + Constants.TEXT + log); // expect 7fixed
        new Second();
        System.out.println(log.trim()); // expect First.a First.static Second.c argument b block First() d Second(int) Second()
        log = "";
        new Second(1);
        System.out.println(log.trim()); // expect b block First() d Second(int)
        log = "";
        System.out.println(Constants.MADE + log.trim()); // expect 8Constants
        First[] none = new First[2];
        System.out.println(none.length); // expect 2
    }
}
