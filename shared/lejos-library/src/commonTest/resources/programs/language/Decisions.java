import josx.platform.rcx.LCD;

public class Decisions {
    static int calls = 0;

    static boolean yes() {
        calls++;
        return true;
    }

    static int grade(int points) {
        if (points >= 90) {
            return 1;
        } else if (points >= 50) {
            return 3;
        } else {
            return 6;
        }
    }

    public static void main(String[] arguments) {
        LCD.showNumber(grade(95)); // shows: 1
        LCD.showNumber(grade(50)); // shows: 3
        LCD.showNumber(grade(-1)); // shows: 6
        boolean result = false && yes();
        LCD.showNumber(calls); // shows: 0
        result = true || yes();
        LCD.showNumber(calls); // shows: 0
        result = false & yes() | yes();
        LCD.showNumber(calls); // shows: 2
        LCD.showNumber(result ? 7 : 8); // shows: 7
        LCD.showNumber(!result ^ true ? 7 : 8); // shows: 7
    }
}
