public class Arithmetic {
    public static void main(String[] arguments) {
        int a = 17;
        int b = -5;
        System.out.println(a + b); // expect 12
        System.out.println(a - b); // expect 22
        System.out.println(a * -b); // expect 85
        System.out.println(-(a / b)); // expect 3
        System.out.println(a % b); // expect 2
        System.out.println(-(-a % b)); // expect 2
        a += 3;
        a -= 1;
        a *= 2;
        a /= 3;
        a %= 7;
        System.out.println(a++); // expect 5
        System.out.println(++a); // expect 7
        System.out.println(--a - a--); // expect 0
        System.out.println(Integer.MAX_VALUE + 1 == Integer.MIN_VALUE ? 1 : 0); // expect 1
    }
}
