import josx.platform.rcx.LCD;

/** A division by zero is no RuntimeException on a brick; who catches every Exception catches it everywhere. */
public class CaughtDivision {
    public static void main(String[] args) throws InterruptedException {
        int zero = 0;
        int caught = 0;
        try {
            try {
                caught = 7 / zero;
            } catch (RuntimeException asInJava) {
                caught = 1;
            }
        } catch (Exception asOnBrick) {
            caught = 2;
        }
        LCD.showNumber(caught);
        Thread.sleep(2000);
    }
}
// brick display: 0002 0
// forgiving display: 0001 0
