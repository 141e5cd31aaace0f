import josx.platform.rcx.LCD;

public class MainWithoutArguments {
    public static void main(String[] arguments) {
        LCD.showNumber(arguments == null ? 1 : 2); // shows: 1
    }
}
