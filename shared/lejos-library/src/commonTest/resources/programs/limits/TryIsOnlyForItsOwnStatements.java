import josx.platform.rcx.LCD;

public class TryIsOnlyForItsOwnStatements {
    static void fail() {
        throw new RuntimeException();
    }

    static void call() {
        fail();
        try {
            LCD.showNumber(90);
        } catch (RuntimeException fromBefore) {
            LCD.showNumber(91);
        }
    }

    public static void main(String[] arguments) {
        try {
            call();
        } catch (RuntimeException notCaughtThere) {
            LCD.showNumber(1); // shows: 1
        }
    }
}
// mode: forgiving
