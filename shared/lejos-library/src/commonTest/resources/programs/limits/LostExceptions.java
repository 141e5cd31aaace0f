import josx.platform.rcx.LCD;

/** After a failed cast or array, a brick enters the handler without the exception. */
public class LostExceptions {
    static void array(int length) {
        try {
            byte[] bytes = new byte[length];
            LCD.showNumber(bytes.length); // brick shows: 3 // forgiving shows: 3 600
        } catch (OutOfMemoryError error) {
            LCD.showNumber(error == null ? 1 : 2); // brick shows: 1 1 // forgiving shows: 2
        }
    }

    static int[] made(int length) {
        return new int[length];
    }

    static void cast(Object object) {
        try {
            String text = (String) object;
            LCD.showNumber(text.length()); // shows: 4
        } catch (ClassCastException exception) {
            LCD.showNumber(exception == null ? 1 : 2); // brick shows: 1 // forgiving shows: 2
        }
    }

    public static void main(String[] arguments) {
        array(3);
        array(-1);
        array(600);
        try {
            made(-2);
        } catch (Throwable error) {
            LCD.showNumber(error == null ? 5 : 6); // brick shows: 5 // forgiving shows: 6
        }
        cast("four");
        cast(new Integer(4));
    }
}
