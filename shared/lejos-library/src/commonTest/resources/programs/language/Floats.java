import josx.platform.rcx.LCD;

public class Floats {
    public static void main(String[] arguments) {
        float a = 2.5f;
        float b = -0.5f;
        LCD.showNumber((int) (a + b)); // shows: 2
        LCD.showNumber((int) (a * 3)); // shows: 7
        LCD.showNumber((int) (a / b)); // shows: 9999
        LCD.showNumber((int) -(a / b)); // shows: 5
        LCD.showNumber((int) (a - b)); // shows: 3
        LCD.showNumber(a > b ? 1 : 0); // shows: 1
        LCD.showNumber(a <= b ? 1 : 0); // shows: 0
        LCD.showNumber(a == 2.5f ? 1 : 0); // shows: 1
        LCD.showNumber((int) -2.9f + 10); // shows: 8
        double wide = 1.25;
        wide = wide * 4;
        LCD.showNumber((int) wide); // shows: 5
        float sum = 0;
        for (int count = 0; count < 10; count++) sum += 0.1f;
        LCD.showNumber((int) (sum * 1000)); // shows: 1000
        LCD.showNumber(1.0f / 0 > 1000 ? 1 : 0); // shows: 1
    }
}
