public class ThrowingAndCatching {
    static class TooHot extends Exception {
        final int degrees;

        TooHot(int degrees) {
            super("too hot");
            this.degrees = degrees;
        }
    }

    static void measure(int degrees) throws TooHot {
        if (degrees > 30) throw new TooHot(degrees);
    }

    public static void main(String[] arguments) {
        try {
            measure(20);
            System.out.println(1); // expect 1
            measure(35);
            System.out.println(2);
        } catch (TooHot heat) {
            System.out.println(heat.degrees); // expect 35
            System.out.println(heat.getMessage().length()); // expect 7
        }
        try {
            measure(40);
        } catch (Exception any) {
            System.out.println(any instanceof TooHot ? 1 : 0); // expect 1
        }
        try {
            throw new IllegalStateException();
        } catch (IllegalArgumentException wrong) {
            System.out.println(5);
        } catch (RuntimeException right) {
            System.out.println(right.getMessage() == null ? 6 : 7); // expect 6
        }
    }
}
