public class Floats {
    public static void main(String[] arguments) {
        float a = 2.5f;
        float b = -0.5f;
        System.out.println((int) (a + b)); // expect 2
        System.out.println((int) (a * 3)); // expect 7
        System.out.println((int) (a / b)); // expect -5
        System.out.println((int) -(a / b)); // expect 5
        System.out.println((int) (a - b)); // expect 3
        System.out.println(a > b ? 1 : 0); // expect 1
        System.out.println(a <= b ? 1 : 0); // expect 0
        System.out.println(a == 2.5f ? 1 : 0); // expect 1
        System.out.println((int) -2.9f + 10); // expect 8
        double wide = 1.25;
        wide = wide * 4;
        System.out.println((int) wide); // expect 5
        float sum = 0;
        for (int count = 0; count < 10; count++) sum += 0.1f;
        System.out.println((int) (sum * 1000)); // expect 1000
        System.out.println(1.0f / 0 > 1000 ? 1 : 0); // expect 1
    }
}
