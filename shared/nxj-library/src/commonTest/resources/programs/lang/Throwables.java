public class Throwables {
    public static void main(String[] arguments) {
        Throwable plain = new Exception();
        System.out.println(plain.getMessage()); // prints: null
        Throwable told = new RuntimeException("told", plain);
        System.out.println(told.getMessage() + " " + (told.getCause() == plain)); // prints: told true
        System.out.println(new Error("error").getMessage()); // prints: error
        System.out.println(new RuntimeException(plain).getCause() == plain); // prints: true
        try {
            Integer.parseInt("x");
        } catch (IllegalArgumentException wrong) {
            System.out.println(wrong instanceof NumberFormatException); // prints: true
        }
        Throwable open = new Throwable("open");
        open.initCause(plain);
        System.out.println(open.getCause() == plain); // prints: true
        System.out.println(open.getLocalizedMessage()); // prints: open
        try {
            throw new Error("thrown");
        } catch (Throwable any) {
            System.out.println(any.getMessage()); // prints: thrown
        }
    }
}
