import josx.platform.rcx.LCD;

public class LargeSteps {
    public static void main(String[] arguments) {
        int number = 1;
        number += 100;
        number = number + 1000;
        number += 2000;
        number -= 500;
        LCD.showNumber(number); // shows: 2601
    }
}
