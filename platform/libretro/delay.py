#!/usr/bin/env python3
"""delay.py FROM TO LOW HIGH: hands a TCP connection on between two ports of this machine, each piece LOW to HIGH
milliseconds late and never before an earlier one."""
import asyncio, random, sys

rng = random.Random(1)


async def send(queue, writer):
    while True:
        due, data = await queue.get()
        await asyncio.sleep(max(0, due - asyncio.get_running_loop().time()))
        if not data:
            return
        writer.write(data)


async def pump(reader, writer, low, high):
    queue, last = asyncio.Queue(), 0
    sender = asyncio.create_task(send(queue, writer))
    data = b"-"
    while data:
        try:
            data = await reader.read(65536)
        except ConnectionError:
            data = b""
        last = max(last, asyncio.get_running_loop().time() + rng.uniform(low, high) / 1000)
        await queue.put((last, data))
    await sender
    writer.close()


async def main(here, there, low, high):
    async def client(reader, writer):
        far_reader, far_writer = await asyncio.open_connection("127.0.0.1", there)
        await asyncio.gather(pump(reader, far_writer, low, high), pump(far_reader, writer, low, high))
    async with await asyncio.start_server(client, "127.0.0.1", here) as server:
        await server.serve_forever()


asyncio.run(main(int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3]), float(sys.argv[4])))
