public class Throwables {
    public static void main(String[] arguments) {
        Throwable plain = new Exception();
        System.out.println(plain.getMessage()); // expect null
        Throwable told = new RuntimeException("told", plain);
        System.out.println(told.getMessage() + " " + (told.getCause() == plain)); // expect told true
        System.out.println(new Error("error").getMessage()); // expect error
        System.out.println(new RuntimeException(plain).getCause() == plain); // expect true
        try {
            Integer.parseInt("x");
        } catch (IllegalArgumentException wrong) {
            System.out.println(wrong instanceof NumberFormatException); // expect true
        }
        Throwable open = new Throwable("open");
        open.initCause(plain);
        System.out.println(open.getCause() == plain); // expect true
        System.out.println(open.getLocalizedMessage()); // expect open
        try {
            throw new Error("thrown");
        } catch (Throwable any) {
            System.out.println(any.getMessage()); // expect thrown
        }
    }
}
